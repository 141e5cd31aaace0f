package robotran.ui.screen

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import kotlinx.coroutines.runBlocking
import robotran.ui.RobotranApp
import robotran.ui.screen.tags.ScreenTags
import robotran.workshop.Workshop
import robotran.workshop.openWorkshop

/** Shows the app on a screen of this size in dp, with a manual clock, and runs [check]. */
@OptIn(ExperimentalTestApi::class)
internal fun onScreen(width: Int, height: Int, check: ComposeUiTest.(Workshop) -> Unit) {
    val workshop = runBlocking { openWorkshop() }
    onScreenOf(workshop, width, height) { check(workshop) }
}

/**
 * Shows [workshop] on a screen of this size in dp, with a manual clock, runs [check], and closes it.
 *
 * A test renders a frame before each look at the tree. Drawing it in software would take most of the test's time, and
 * only a picture shows it, so frames are composed and laid out, but drawn for [pixelsOf] and at the end only.
 */
@OptIn(ExperimentalTestApi::class)
internal fun onScreenOf(
    workshop: Workshop,
    width: Int,
    height: Int,
    embedded: Boolean = false,
    check: ComposeUiTest.() -> Unit,
) {
    try {
        undrawnTest(width, height) {
            mainClock.autoAdvance = false
            setContent { Undrawn { RobotranApp(workshop, dark = false, embedded = embedded) } }
            pass(SETTLE_MILLIS)
            check()
            drawn { pass(1) } // Drawing must not fail on whatever the test has led to.
        }
    } finally {
        workshop.close()
    }
}

/** A tablet in landscape. */
@OptIn(ExperimentalTestApi::class)
internal fun onTablet(check: ComposeUiTest.(Workshop) -> Unit) = onScreen(1280, 800, check)

/** A tablet in landscape that shows the whole brick. */
@OptIn(ExperimentalTestApi::class)
internal fun onTabletWithBrick(check: ComposeUiTest.(Workshop) -> Unit) = onTablet { workshop ->
    showWholeBrick()
    check(workshop)
}

@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.showWholeBrick() {
    onNodeWithTag(ScreenTags.BRICK_SIZE).performClick()
    pass(SETTLE_MILLIS)
}

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

private const val SETTLE_MILLIS = 100L
