# Cross-parameterizes many pairs of models; what belongs to one model is made once and shared by all its pairs.
#
#   make -f pipelines/batch.mk MODELS=folder PAIRS="cat:lion cow:camel" OUT=folder
#
# MODELS holds NAME.ply (or .obj, .off, .stl) and NAME.sketch.json; SKETCHES=folder when the sketches lie elsewhere.
# PAIRS are SOURCE:TARGET names, or "all" for every ordered pair. OUT receives models/NAME.* and SOURCE-TARGET/*, the
# latter as in cross-parameterize.mk. A pair that fails does not stop the others; the table at the end shows it, and
# the exit code is not 0. What is there and up to date is not made again; -j works side by side.
# `results` makes the same without the table. Options of single stages: see stages.mk.
batch_makefile := $(lastword $(MAKEFILE_LIST))
include $(dir $(batch_makefile))stages.mk

SKETCHES ?= $(MODELS)
PAIRS ?= all
$(call check_input,MODELS,folder)
$(call check_input,SKETCHES,folder)
$(call check_path,OUT)
$(if $(OUT),,$(error OUT is not given; say OUT=folder for the results))

mesh_of = $(firstword $(wildcard $(foreach format,ply obj off stl,$(MODELS)/$(1).$(format))))
source_of = $(word 1,$(subst :, ,$(1)))
target_of = $(word 2,$(subst :, ,$(1)))
folder_of = $(OUT)/$(call source_of,$(1))-$(call target_of,$(1))

ifeq ($(strip $(PAIRS)),all)
  # A name with a dot, such as that of X.segment.ply, is a stage's document, not a model.
  every_mesh := $(wildcard $(foreach format,ply obj off stl,$(MODELS)/*.$(format)))
  every_model := $(foreach name,$(sort $(notdir $(basename $(every_mesh)))),$(if $(findstring .,$(name)),,$(name)))
  pairs := $(foreach s,$(every_model),$(foreach t,$(filter-out $(s),$(every_model)),$(s):$(t)))
else
  pairs := $(sort $(PAIRS))
endif
$(foreach pair,$(pairs),$(if $(filter 2,$(words $(subst :, ,$(pair)))),,$(error \
  PAIRS: "$(pair)" is not SOURCE:TARGET)))
$(if $(pairs),,$(error PAIRS: there is no pair to make; $(MODELS) needs two meshes at the least))
models := $(sort $(subst :, ,$(pairs)))
$(foreach name,$(models),$(if $(call mesh_of,$(name)),,$(error \
  PAIRS: there is no $(MODELS)/$(name).ply (or .obj, .off, .stl))))
measures := $(foreach pair,$(pairs),$(call folder_of,$(pair))/measure.json)

.PHONY: table results
table:
	@status=0; done='$(measures)'; failed=; \
	$(MAKE) --no-print-directory --keep-going -f $(batch_makefile) results || status=$$?; \
	if [ $$status != 0 ]; then \
	  done=; \
	  for measure in $(measures); do \
	    if $(MAKE) --no-print-directory -q -f $(batch_makefile) $$measure >/dev/null 2>&1; \
	    then done="$$done $$measure"; \
	    else failed="$$failed $$(basename $$(dirname $$measure))"; \
	    fi; \
	  done; \
	fi; \
	[ -z "$$done" ] || '$(PARTWISE_BIN)/measure' --summary $$done || status=$$?; \
	for pair in $$failed; do echo "failed: $$pair (its message is above)" >&2; done; \
	exit $$status
results: $(measures)

$(foreach name,$(models),$(eval $(call model_rules,$(OUT)/models/$(name),$(call \
  mesh_of,$(name)),$(wildcard $(SKETCHES)/$(name).sketch.json))))
$(foreach pair,$(pairs),$(eval $(call pair_rules,$(call folder_of,$(pair)),$(OUT)/models/$(call \
  source_of,$(pair)),$(OUT)/models/$(call target_of,$(pair)))))
