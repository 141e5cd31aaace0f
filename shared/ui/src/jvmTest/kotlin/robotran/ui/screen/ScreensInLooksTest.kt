package robotran.ui.screen

import robotran.language.Language

/** Each window in one look, each look on several windows; `thorough` tests all looks on all windows. */
class ScreensInLooksTest : ScreensInLooks() {
    override fun looksOn(number: Int): List<Look> =
        listOf(Look(Language.entries[number % Language.entries.size], if (number % 2 == 0) 2f else 1f))
}
