@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

import kotlinx.browser.document
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.launch
import robotran.ui.RobotranStart
import robotran.web.embedding.Embedding
import robotran.web.embedding.reportToParent
import robotran.web.grading.gradeForPage
import robotran.web.grading.isWorker
import robotran.web.platform.WebPlatform
import robotran.web.platform.askBeforeLosing
import robotran.web.platform.onOutOfSight
import robotran.web.window.PageFonts
import robotran.web.window.PageWindow
import robotran.workshop.Workshop

/** Creates the workshop in the page and then removes the loading screen; in a worker, grades for the page. */
fun main() {
    // Lives as long as the page. A failed coroutine does not cancel the others.
    val scope = CoroutineScope(SupervisorJob() + Dispatchers.Default)
    if (isWorker()) gradeForPage(scope) else openPage(scope)
}

private fun openPage(scope: CoroutineScope) {
    val page = checkNotNull(document.body) { "The page has no body." }
    findResourcesInSite()
    val embedding = Embedding.asked()
    val isEmbedded = embedding != Embedding.NONE
    val fonts = PageFonts()
    val platform = WebPlatform(WebSpeaker(), isEmbedded, fonts)
    PageWindow(page, fonts, hasHistory = !isEmbedded) {
        val isSheet = embedding == Embedding.SHEET
        RobotranStart(platform = platform, welcoming = !isEmbedded, embedded = isSheet, onOpened = { workshop ->
            openPageInterface(workshop, scope)
            if (!isEmbedded) saveOnPageHide(workshop, scope)
            if (embedding == Embedding.ASSIGNMENT) scope.launch { reportToParent(workshop) }
            scope.launch { fulfilWish(workshop) }
            notifyAppStarted()
        })
    }
}

/** Saves the project when the page is closed, reloaded or suspended. */
private fun saveOnPageHide(workshop: Workshop, scope: CoroutineScope) {
    // Code that runs later may never run, so everything possible is done synchronously.
    onOutOfSight { scope.launch(Dispatchers.Unconfined) { workshop.hideDocument() } }
    askBeforeLosing { workshop.state.document.error != null }
}
