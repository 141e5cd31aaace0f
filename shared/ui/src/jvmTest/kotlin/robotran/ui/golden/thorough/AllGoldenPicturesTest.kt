package robotran.ui.golden.thorough

import robotran.ui.golden.GoldenScenes

class AllGoldenPicturesTest : GoldenScenes() {
    override fun isCompared(scene: Scene, screen: Screen, look: Look): Boolean = true
}
