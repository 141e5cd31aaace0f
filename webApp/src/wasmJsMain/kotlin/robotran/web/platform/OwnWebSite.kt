@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.platform

import kotlinx.coroutines.await
import robotran.assignments.packaging.SiteFile
import robotran.workshop.platform.WebSite
import kotlin.io.encoding.Base64
import kotlin.js.Promise

/** The site that this page is of. The service worker's script lists its files. */
internal object OwnWebSite : WebSite {
    override suspend fun files(): List<SiteFile>? {
        val paths = pathsOfFiles().await<JsString?>()?.toString()?.lines() ?: return null
        return paths.map { path ->
            val bytes = fetchBytes(path).await<JsString?>()?.toString() ?: return null
            SiteFile(path, Base64.decode(bytes))
        }
    }
}

/** One path per line; null if the list cannot be fetched. The empty path in it is the page. */
private fun pathsOfFiles(): Promise<JsString?> = js(
    """fetch('service-worker.js')
        .then((answer) => (answer.ok ? answer.text() : Promise.reject()))
        .then((script) => JSON.parse(/const FILES = (.*);/.exec(script)[1]))
        .then((files) => files.map(([path]) => path || 'index.html'))
        .then((paths) => [...paths, 'service-worker.js', 'embedding.json'].join('\n'))
        .catch(() => null)""",
)

/** The file in Base64, which passes bytes to Kotlin in one piece; null if it cannot be fetched. */
private fun fetchBytes(path: String): Promise<JsString?> = js(
    """fetch(path)
        .then((answer) => (answer.ok ? answer.arrayBuffer() : Promise.reject()))
        .then((buffer) => {
            const bytes = new Uint8Array(buffer);
            const letters = [];
            for (let place = 0; place < bytes.length; place += 8192) {
                letters.push(String.fromCharCode(...bytes.subarray(place, place + 8192)));
            }
            return btoa(letters.join(''));
        })
        .catch(() => null)""",
)
