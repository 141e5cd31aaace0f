package robotran.android

import android.content.pm.PackageManager
import android.graphics.Bitmap
import android.graphics.Canvas
import android.graphics.Insets
import android.view.WindowInsets
import androidx.compose.ui.graphics.toArgb
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.assertTextContains
import androidx.compose.ui.test.hasSetTextAction
import androidx.compose.ui.test.junit4.createAndroidComposeRule
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.performTouchInput
import org.junit.Assert.assertEquals
import org.junit.Assert.assertTrue
import org.junit.Before
import org.junit.Rule
import org.junit.Test
import org.junit.runner.RunWith
import org.robolectric.RobolectricTestRunner
import org.robolectric.RuntimeEnvironment
import org.robolectric.annotation.Config
import robotran.brick.controls.BrickButton
import robotran.ui.run.tags.RunTags
import robotran.ui.school.tags.LearningTags
import robotran.ui.sheet.SheetColours
import robotran.ui.world.tags.WorldTags
import robotran.uikit.KitTags
import java.io.File

@RunWith(RobolectricTestRunner::class)
class MainActivityTest {
    @get:Rule(order = 0)
    val resources = ResourcesOfCompose()

    @get:Rule(order = 1)
    val screen = createAndroidComposeRule<MainActivity>()

    /** While the robot drives there is always a next frame, so the tests advance the clock manually. */
    @Before
    fun stopTheClock() {
        screen.mainClock.autoAdvance = false
        screen.mainClock.advanceTimeBy(SETTLING)
        screen.onNodeWithTag(LearningTags.FIRST_TEXT).performSemanticsAction(SemanticsActions.OnClick)
        screen.onNodeWithTag(KitTags.close(LearningTags.FIRST_RUN)).performClick()
        screen.mainClock.advanceTimeBy(SETTLING)
    }

    @Test
    @Config(qualifiers = PHONE)
    fun `on a phone the robot draws a square after Run on the brick`() = drawSquare("phone")

    @Test
    @Config(qualifiers = TABLET)
    fun `on a tablet the robot draws a square after Run on the brick`() = drawSquare("tablet")

    @Test
    @Config(qualifiers = PHONE)
    fun `a run and the program text survive a turn of the phone`() {
        pressRunOnTheBrick()
        screen.mainClock.advanceTimeBy(WHOLE_SQUARE)
        choose("Program")
        screen.onNode(hasSetTextAction()).performTextReplacement("forward 7")
        turnToLandscape()
        screen.onNode(hasSetTextAction()).assertTextContains("forward 7")
        choose("World")
        assertEquals(80.0, inkCentimetres(), 1.0)
    }

    @Test
    @Config(qualifiers = PHONE)
    fun `nothing to touch lies under the bars of the system`() {
        val bars = WindowInsets.Builder().setInsets(WindowInsets.Type.systemBars(), Insets.of(0, 90, 0, 120)).build()
        val window = screen.activity.window.decorView
        screen.runOnUiThread { window.dispatchApplyWindowInsets(bars) }
        screen.mainClock.advanceTimeBy(SETTLING)
        photograph("phone-bars")
        assertTrue(screen.onNodeWithText("Program").fetchSemanticsNode().boundsInRoot.top >= 90)
        assertTrue(screen.onNodeWithTag(RunTags.STOP).fetchSemanticsNode().boundsInRoot.bottom <= window.height - 120)
    }

    @Test
    fun `the app has no permissions but those for hubs by Bluetooth`() {
        val app = screen.activity
        val all = app.packageManager.getPackageInfo(app.packageName, PackageManager.GET_PERMISSIONS)
        val hubs = setOf("BLUETOOTH", "BLUETOOTH_ADMIN", "BLUETOOTH_SCAN", "BLUETOOTH_CONNECT") +
            setOf("ACCESS_COARSE_LOCATION", "ACCESS_FINE_LOCATION")
        val others = all.requestedPermissions.orEmpty().map { it.removePrefix("android.permission.") } - hubs
        assertEquals(emptyList<String>(), others)
    }

    private fun drawSquare(device: String) {
        assertEquals(0.0, inkCentimetres(), 0.0)
        val before = photograph("$device-before")
        pressRunOnTheBrick()
        screen.mainClock.advanceTimeBy(HALF_SQUARE)
        val half = photograph("$device-running")
        screen.mainClock.advanceTimeBy(WHOLE_SQUARE - HALF_SQUARE)
        val whole = photograph("$device-done")
        assertEquals(80.0, inkCentimetres(), 1.0)
        assertEquals(0, before.inkPixels())
        assertTrue("half a square is less ink than a whole one", half.inkPixels() in 1 until whole.inkPixels())
    }

    private fun pressRunOnTheBrick() {
        screen.onNodeWithTag(RunTags.button(BrickButton.RUN)).performTouchInput { down(center) }
        screen.mainClock.advanceTimeBy(PRESS)
        screen.onNodeWithTag(RunTags.button(BrickButton.RUN)).performTouchInput { up() }
        screen.mainClock.advanceTimeBy(SETTLING)
    }

    private fun choose(tab: String) {
        screen.onNodeWithText(tab).performClick()
        screen.mainClock.advanceTimeBy(SETTLING)
    }

    private fun turnToLandscape() {
        RuntimeEnvironment.setQualifiers("+land")
        screen.activityRule.scenario.recreate()
        screen.mainClock.advanceTimeBy(SETTLING)
        val size = screen.activity.window.decorView
        assertTrue(size.width > size.height)
    }

    /** The accessibility text of the paper ends with "80.0 cm of line drawn". */
    private fun inkCentimetres(): Double {
        val words = screen.onNodeWithTag(WorldTags.WORLD)
            .fetchSemanticsNode().config[SemanticsProperties.ContentDescription].joinToString()
        return words.substringBefore(" cm of line").substringAfterLast(' ').toDouble()
    }

    /** Draws the activity and saves the screenshot for review. */
    private fun photograph(name: String): Bitmap {
        val window = screen.activity.window.decorView
        val picture = Bitmap.createBitmap(window.width, window.height, Bitmap.Config.ARGB_8888)
        window.draw(Canvas(picture))
        val folder = File(System.getProperty("robotran.pictures")).apply { mkdirs() }
        folder.resolve("$name.png").outputStream().use { picture.compress(Bitmap.CompressFormat.PNG, 100, it) }
        return picture
    }

    private fun Bitmap.inkPixels(): Int {
        val pixels = IntArray(width * height)
        getPixels(pixels, 0, width, 0, 0, width, height)
        return pixels.count { it == SheetColours.INK.toArgb() }
    }

    private companion object {
        const val PHONE = "w411dp-h891dp-420dpi"
        const val TABLET = "w1280dp-h800dp-land-xhdpi"

        /** Milliseconds. */
        const val PRESS = 200L
        const val SETTLING = 100L
        const val HALF_SQUARE = 3_900L
        const val WHOLE_SQUARE = 8_000L
    }
}
