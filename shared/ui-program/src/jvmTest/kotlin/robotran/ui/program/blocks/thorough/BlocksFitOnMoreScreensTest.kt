package robotran.ui.program.blocks.thorough

import robotran.ui.program.blocks.BlocksOnScreens

class BlocksFitOnMoreScreensTest : BlocksOnScreens() {
    override val sizes = listOf(Size(411, 891), Size(891, 411), Size(1280, 800), Size(1440, 900))
}
