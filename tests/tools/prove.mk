# SPDX-License-Identifier: MIT
# tests/proof: each .c is a proof (its proof.h says how they are written). PROOFS="fixed edges": of these alone.
PROOFS ?= $(patsubst tests/proof/%.c,%,$(wildcard tests/proof/*.c))

prove-run:
	@tests/tools/prove.py -o $(BUILD)/proof $(PROOFS:%=tests/proof/%.c)

.PHONY: prove-run
