package robotran.web

import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.window.ComposeViewport
import kotlinx.browser.document
import kotlinx.coroutines.DelicateCoroutinesApi
import kotlinx.coroutines.GlobalScope
import kotlinx.coroutines.launch
import robotran.ui.RobotranStart
import robotran.ui.workshop.Workshop
import robotran.web.platform.WebPlatform
import robotran.web.platform.askBeforeLosing
import robotran.web.platform.onOutOfSight

/** Puts the workshop into the page, and takes away the words that are shown while it loads once it is there. */
@OptIn(ExperimentalComposeUiApi::class)
fun main() {
    val page = checkNotNull(document.body) { "The page has no body." }
    findResourcesInSite()
    val platform = WebPlatform(WebSpeaker())
    ComposeViewport(page) {
        RobotranStart(platform = platform, onOpened = { workshop ->
            openPageInterface(workshop)
            keepWork(workshop)
            sayThatAppIsThere()
        })
    }
}

/** Loses nothing when the page is closed, reloaded or put to sleep. */
@OptIn(DelicateCoroutinesApi::class)
private fun keepWork(workshop: Workshop) {
    onOutOfSight { GlobalScope.launch { workshop.restDocument() } }
    askBeforeLosing { workshop.state.document.trouble != null }
}
