package robotran.ui.screen

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import kotlinx.coroutines.runBlocking
import robotran.workshop.Workshop
import robotran.workshop.openWorkshop

/** Shows the app on a screen of this size in dp, with a manual clock, and runs [check]. */
@OptIn(ExperimentalTestApi::class)
internal fun onScreen(width: Int, height: Int, check: ComposeUiTest.(Workshop) -> Unit) {
    val workshop = runBlocking { openWorkshop() }
    onScreenOf(workshop, width, height) { check(workshop) }
}

/** A tablet in landscape. */
@OptIn(ExperimentalTestApi::class)
internal fun onTablet(check: ComposeUiTest.(Workshop) -> Unit) = onScreen(1280, 800, check)

/** A phone in portrait. */
@OptIn(ExperimentalTestApi::class)
internal fun onPhone(check: ComposeUiTest.(Workshop) -> Unit) = onScreen(411, 891, check)

/** Advances the clock by at least [milliseconds], frame by frame. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.pass(milliseconds: Long) {
    val end = mainClock.currentTime + milliseconds
    while (mainClock.currentTime < end) mainClock.advanceTimeByFrame()
    waitForIdle()
}
