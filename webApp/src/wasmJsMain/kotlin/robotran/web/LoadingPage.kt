@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

import org.jetbrains.compose.resources.ExperimentalResourceApi
import org.jetbrains.compose.resources.configureWebResources

/** Fonts and texts have content hashes in their names; the page's script, `src/site/start.js`, maps them. */
@OptIn(ExperimentalResourceApi::class)
internal fun findResourcesInSite() = configureWebResources { resourcePathMapping(::addressOf) }

private fun addressOf(path: String): String = js("globalThis.robotranPage.addressOf(path)")

/** Removes the loading screen, and allows the page to be cached for offline use. */
internal fun notifyAppStarted(): Unit = js("globalThis.robotranPage.started()")
