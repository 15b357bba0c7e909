# What is compiled into edaha: every file of styles/ and leaves/, by name. A test compares these
# lists with the folders.
set(EDAHA_STYLES)
set(EDAHA_LEAVES
  apple
  apple-leaf
  birch
  cherry-blossom
  cherry-leaf
  cherry-petal
  cypress-spray
  fir-spray
  ginkgo
  laurel
  maple
  oak
  pine-tuft
  plum-blossom
  poplar
  round
  willow
  zelkova)
