@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

import kotlinx.browser.document
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.launch
import robotran.ui.RobotranStart
import robotran.web.platform.WebPlatform
import robotran.web.platform.askBeforeLosing
import robotran.web.platform.onOutOfSight
import robotran.web.window.PageFonts
import robotran.web.window.PageWindow
import robotran.workshop.Workshop

/** Creates the workshop in the page and then removes the loading screen. */
fun main() {
    val page = checkNotNull(document.body) { "The page has no body." }
    // Lives as long as the page. A failed coroutine does not cancel the others.
    val scope = CoroutineScope(SupervisorJob() + Dispatchers.Default)
    findResourcesInSite()
    val embedded = isEmbedded()
    val fonts = PageFonts()
    val platform = WebPlatform(WebSpeaker(), embedded, fonts)
    PageWindow(page, fonts, hasHistory = !embedded) {
        RobotranStart(platform = platform, welcoming = !embedded, embedded = embedded, onOpened = { workshop ->
            openPageInterface(workshop, scope)
            if (!embedded) saveOnPageHide(workshop, scope)
            fulfilWish(workshop)
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

/** Whether the URL requests only world and brick, to embed them in another page: `?embed`. */
private fun isEmbedded(): Boolean = js("new URLSearchParams(location.search).has('embed')")
