package robotran.ui.golden.thorough

import robotran.ui.golden.SpaceScenes
import robotran.ui.golden.SpaceScreen
import robotran.workshop.state.AppTheme

class AllSpacePicturesTest : SpaceScenes() {
    override fun isCompared(number: Int, screen: SpaceScreen, theme: AppTheme): Boolean = true
}
