# Pages to look at: of a pair that cross-parameterize.mk made in OUT, or of all pairs that batch.mk made there.
#
#   make -f pipelines/report.mk OUT=folder
#
# A pair gets OUT/report.html; a batch OUT/PAIR/report.html for each pair of which there is something to see, and
# OUT/index.html, a table of all. The pages need no network and no other files.
# `contact-sheet` draws source, compatible mesh and target of every finished pair into one picture, by POV-Ray and
# without a browser: OUT/contact-sheet.png, SHEET_WIDTH pixels wide.
# Options of the pages: REPORT_FLAGS, INDEX_FLAGS.
include $(dir $(lastword $(MAKEFILE_LIST)))stages.mk

SHEET_WIDTH ?= 1800
SHEET_PAIRS ?= 2
$(call check_path,OUT)
$(if $(OUT),,$(error OUT is not given; say OUT=folder of a pair or of a batch))

ifneq ($(wildcard $(foreach name,crossmap reconstructed critical compatible source.segment target.segment,$(OUT)/$(name).ply)),)
  folders := $(OUT)
  index :=
else
  folders := $(sort $(patsubst %/,%,$(dir $(wildcard $(foreach name,crossmap.ply compatible.ply measure.json,$(OUT)/*/$(name))))))
  index := $(OUT)/index.html
  $(if $(wildcard $(OUT)/*/.settings/crossmap)$(folders),,$(error OUT="$(OUT)": there is no pair in this folder))
endif
pages := $(addsuffix /report.html,$(folders))

.PHONY: report contact-sheet
report: $(pages) $(index)

# $(call models_of,FOLDER): documents of the models of a batch that may belong to this pair.
models_of = $(foreach file,$(wildcard $(1)/../models/*.ply),$(if $(findstring $(firstword $(subst ., ,$(notdir \
  $(file)))),$(notdir $(abspath $(1)))),$(file)))
# Whatever lies in the folders of the pair and its models may be on its page.
define page_rule
$(1)/report.html: $(wildcard $(1)/*.ply $(1)/*.json) $(call models_of,$(1)) $(call \
  settings,$(1)/.settings/report,$(REPORT_FLAGS))
	'$$(PARTWISE_BIN)/report' $(1) $(REPORT_FLAGS) --force -o $$@
endef
$(foreach folder,$(folders),$(eval $(call page_rule,$(folder))))

ifneq ($(index),)
.PHONY: $(index)
$(index): $(pages)
	'$(PARTWISE_BIN)/report' --index $(OUT) $(INDEX_FLAGS) --force -o $@
endif

sheet_meshes := $(wildcard $(addsuffix /compatible.ply,$(folders)))
sheet_panels := $(foreach mesh,$(sheet_meshes),source=$(mesh) $(mesh) target=$(mesh))
sheet_captions := $(foreach mesh,$(sheet_meshes),--caption=auto --caption=$(notdir $(abspath $(dir $(mesh)))) --caption=auto)

contact-sheet: $(OUT)/contact-sheet.png
$(OUT)/contact-sheet.png: $(sheet_meshes) $(call settings,$(OUT)/.settings/contact-sheet,$(sheet_meshes) $(SHEET_WIDTH) $(SHEET_PAIRS))
	$(if $(sheet_meshes),,$(error OUT="$(OUT)": there is no finished pair to draw))
	'$(PARTWISE_BIN)/picture' $(sheet_panels) --columns $$((3 * $(SHEET_PAIRS))) --width $(SHEET_WIDTH) $(sheet_captions) \
	  --force -o $(OUT)/contact-sheet.pov
	$(call povray,$(OUT),contact-sheet)
