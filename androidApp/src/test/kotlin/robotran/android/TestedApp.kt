package robotran.android

import android.content.Intent
import android.graphics.Bitmap
import android.graphics.Canvas
import android.os.Bundle
import android.os.Looper
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.test.junit4.ComposeTestRule
import androidx.compose.ui.test.junit4.createEmptyComposeRule
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performSemanticsAction
import androidx.lifecycle.ViewModelProvider
import org.junit.rules.RuleChain
import org.junit.rules.TestRule
import org.junit.runner.Description
import org.junit.runners.model.Statement
import org.robolectric.Robolectric
import org.robolectric.RuntimeEnvironment
import org.robolectric.Shadows.shadowOf
import org.robolectric.android.controller.ActivityController
import robotran.ui.school.tags.LearningTags
import robotran.uikit.KitTags
import robotran.workshop.Workshop
import java.io.File
import java.util.concurrent.TimeUnit

/**
 * The whole app on Robolectric. While a robot drives there is always a next frame, so the clock is advanced manually.
 */
class TestedApp : TestRule {
    val screen: ComposeTestRule = createEmptyComposeRule()
    private lateinit var controller: ActivityController<MainActivity>

    val activity: MainActivity get() = controller.get()
    val workshop: Workshop get() = checkNotNull(ViewModelProvider(activity)[WorkshopViewModel::class.java].workshop)

    override fun apply(base: Statement, description: Description): Statement =
        RuleChain.outerRule(ResourcesOfCompose()).around(screen).apply(base, description)

    /**
     * Starts the app.
     *
     * @param qualifiers the device, as Robolectric qualifiers.
     * @param saved the saved state of an activity from an ended process.
     */
    fun open(
        qualifiers: String? = null,
        fontScale: Float = 1f,
        intent: Intent = Intent(Intent.ACTION_MAIN),
        saved: Bundle? = null,
    ) {
        screen.mainClock.autoAdvance = false
        qualifiers?.let { RuntimeEnvironment.setQualifiers(it) }
        RuntimeEnvironment.setFontScale(fontScale)
        controller = Robolectric.buildActivity(MainActivity::class.java, intent)
        if (saved == null) controller.setup() else controller.setup(saved)
        val kept = ViewModelProvider(activity)[WorkshopViewModel::class.java]
        waitUntil("The workshop does not open") { kept.workshop != null }
        pass(SETTLING)
    }

    /** Waits for what other threads do, however long a busy machine takes; then complains. */
    fun waitUntil(complaint: String, isTrue: () -> Boolean) {
        val end = System.nanoTime() + TimeUnit.SECONDS.toNanos(LONGEST_WAIT_SECONDS)
        while (!isTrue()) {
            check(System.nanoTime() < end) { complaint }
            Thread.sleep(TURN_MILLISECONDS)
            pass(FRAME)
        }
    }

    /** Chooses text on the welcome page of the first run and closes the page. */
    fun leaveFirstPage() {
        screen.onNodeWithTag(LearningTags.FIRST_TEXT).performSemanticsAction(SemanticsActions.OnClick)
        screen.onNodeWithTag(KitTags.close(LearningTags.FIRST_RUN)).performClick()
        pass(SETTLING)
    }

    /** Advances the clock by at least [milliseconds], frame by frame. */
    fun pass(milliseconds: Long) {
        screen.mainClock.advanceTimeBy(milliseconds)
        shadowOf(Looper.getMainLooper()).idle()
    }

    fun touch(tag: String) {
        screen.onNodeWithTag(tag).performClick()
        pass(SETTLING)
    }

    fun isThere(tag: String) = screen.onAllNodesWithTag(tag).fetchSemanticsNodes().isNotEmpty()

    /** Goes back, as by gesture or button. */
    fun goBack() {
        activity.onBackPressedDispatcher.onBackPressed()
        pass(SETTLING)
    }

    /** Rotates the device or resizes the window. */
    fun change(qualifiers: String) {
        RuntimeEnvironment.setQualifiers(qualifiers)
        controller.configurationChange(RuntimeEnvironment.getApplication().resources.configuration)
        pass(SETTLING)
    }

    fun receive(intent: Intent) {
        controller.newIntent(intent)
        settle()
    }

    /** Simulates that Android ends the hidden app's process and restarts it when the user returns. */
    fun simulateProcessDeath() {
        val saved = Bundle()
        controller.pause().stop().saveInstanceState(saved)
        val kept = ViewModelProvider(activity)[WorkshopViewModel::class.java]
        waitUntil("The work is not kept") { kept.resting?.isCompleted == true }
        controller.destroy()
        settle()
        open(saved = saved)
    }

    /** Waits for work on other threads. */
    fun settle() {
        repeat(TURNS) {
            Thread.sleep(TURN_MILLISECONDS)
            pass(FRAME)
        }
    }

    /** Draws the activity and saves the screenshot for review. */
    fun photograph(name: String): Bitmap {
        val window = activity.window.decorView
        val picture = Bitmap.createBitmap(window.width, window.height, Bitmap.Config.ARGB_8888)
        window.draw(Canvas(picture))
        val folder = File(System.getProperty("robotran.pictures")).apply { mkdirs() }
        folder.resolve("$name.png").outputStream().use { picture.compress(Bitmap.CompressFormat.PNG, 100, it) }
        return picture
    }

    private companion object {
        /** Milliseconds. */
        const val SETTLING = 200L
        const val FRAME = 16L
        const val TURN_MILLISECONDS = 10L
        const val TURNS = 30

        const val LONGEST_WAIT_SECONDS = 60L
    }
}
