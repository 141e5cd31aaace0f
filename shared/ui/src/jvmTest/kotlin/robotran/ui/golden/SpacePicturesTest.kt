package robotran.ui.golden

import robotran.workshop.state.AppTheme

/** Each scene in each theme, on two of the three screens; `thorough` compares all. */
class SpacePicturesTest : SpaceScenes() {
    override fun isCompared(number: Int, screen: SpaceScreen, theme: AppTheme): Boolean =
        (number + if (theme == AppTheme.DARK) 1 else 0) % SpaceScreen.entries.size == screen.ordinal
}
