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

/** Puts the workshop into the page, and takes away the words that are shown while it loads once it is there. */
fun main() {
    val page = checkNotNull(document.body) { "The page has no body." }
    // The page's own: it goes with the page, and what fails in it stops nothing else.
    val scope = CoroutineScope(SupervisorJob() + Dispatchers.Default)
    findResourcesInSite()
    val embedded = isEmbedded()
    val fonts = PageFonts()
    val platform = WebPlatform(WebSpeaker(), embedded, fonts)
    PageWindow(page, fonts, hasHistory = !embedded) {
        RobotranStart(platform = platform, welcoming = !embedded, embedded = embedded, onOpened = { workshop ->
            openPageInterface(workshop, scope)
            if (!embedded) keepWork(workshop, scope)
            sayThatAppIsThere()
        })
    }
}

/** Loses nothing when the page is closed, reloaded or put to sleep. */
private fun keepWork(workshop: Workshop, scope: CoroutineScope) {
    // A page that goes does nothing later: all that can be done at once is.
    onOutOfSight { scope.launch(Dispatchers.Unconfined) { workshop.restDocument() } }
    askBeforeLosing { workshop.state.document.error != null }
}

/** Whether the address asks for world and brick alone, as part of a teacher's page: `?embed`. */
private fun isEmbedded(): Boolean = js("new URLSearchParams(location.search).has('embed')")
