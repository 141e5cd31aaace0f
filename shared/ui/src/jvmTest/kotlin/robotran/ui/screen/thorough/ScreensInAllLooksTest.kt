package robotran.ui.screen.thorough

import robotran.language.Language
import robotran.ui.screen.ScreensInLooks

class ScreensInAllLooksTest : ScreensInLooks() {
    override fun looksOn(number: Int): List<Look> =
        Language.entries.flatMap { language -> listOf(1f, 2f).map { Look(language, it) } }
}
