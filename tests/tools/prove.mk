# SPDX-License-Identifier: MIT
# tests/proof: each .c is a proof (its proof.h says how they are written), wp/*.c too (prove.py). PROOFS="fixed edges": of
# these alone. The scene check's takes longer than all else and has a target of its own.
PROOFS ?= $(filter-out wp/scene_check,$(patsubst tests/proof/%.c,%,$(wildcard tests/proof/*.c tests/proof/wp/*.c)))

prove-run:
	@status=0; $(if $(filter file,$(origin PROOFS)),tests/tools/prove_bounds.py || status=1;) \
	tests/tools/prove.py -o $(BUILD)/proof $(PROOFS:%=tests/proof/%.c) || status=1; exit $$status

prove-planted-run:
	@tests/tools/prove_planted.sh $(BUILD)/proof/planted

.PHONY: prove-run prove-planted-run
