@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

import kotlinx.coroutines.await
import org.jetbrains.compose.resources.ExperimentalResourceApi
import org.jetbrains.compose.resources.configureWebResources
import robotran.projects.ProgramView
import robotran.workshop.Workshop
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.state.LearningPage
import kotlin.js.Promise

/** Fonts and texts have content hashes in their names; the page's script, `src/site/start.js`, maps them. */
@OptIn(ExperimentalResourceApi::class)
internal fun findResourcesInSite() = configureWebResources { resourcePathMapping(::addressOf) }

private fun addressOf(path: String): String = js("globalThis.robotranPage.addressOf(path)")

/**
 * Does what the pupil chose on the loading screen before the app was there, as soon as the page has all parts of the app
 * that this needs.
 */
internal suspend fun fulfilWish(workshop: Workshop) {
    when (view()) {
        "blocks" -> workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        "text" -> workshop.handle(BlockEvent.ViewChosen(ProgramView.TEXT))
    }
    when (wish().await<JsString>().toString()) {
        "square" -> workshop.handle(LearningEvent.FirstProgramTried)
        "tutorial" -> workshop.handle(LearningEvent.TutorialStarted)
        "worlds" -> workshop.handle(LearningEvent.PageRequested(LearningPage.WORLDS))
    }
}

private fun wish(): Promise<JsString> = js("globalThis.robotranPage.wish()")

private fun view(): String = js("globalThis.robotranPage.view()")

/** Removes the loading screen, and allows the page to be cached for offline use. */
internal fun notifyAppStarted(): Unit = js("globalThis.robotranPage.started()")
