# SPDX-License-Identifier: MIT
# tests/proof/wp: contracts that WP alone proves, without a run by Eva.
prove-scene-run:
	@tests/tools/prove_scene.sh $(BUILD)/proof/wp

.PHONY: prove-scene-run
