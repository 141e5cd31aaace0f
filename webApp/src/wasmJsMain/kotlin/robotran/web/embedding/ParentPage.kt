@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.embedding

import kotlinx.coroutines.await
import kotlin.js.Promise

/**
 * The page around this one, if it may know what happens here: it is from the same origin, or the file `embedding.json`
 * of this site names its origin. docs/assignments.md describes the messages.
 */
internal class ParentPage private constructor(private val page: JsAny) {
    /** Sends [message], a JSON object. */
    fun post(message: String) = postTo(page, message)

    /** Calls [take] with each message of the page around, as JSON. */
    fun onMessage(take: (String) -> Unit) = hear(page, take)

    companion object {
        /** null if there is no page around this one, or it may know nothing. */
        suspend fun find(): ParentPage? = findParent().await<JsAny?>()?.let(::ParentPage)
    }
}

/** Where the browser does not tell the origin of the parent, it delivers a message only to the origin it is for. */
private fun findParent(): Promise<JsAny?> = js(
    """(async () => {
        const { parent } = window;
        if (parent === window) return null;
        const list = await fetch('embedding.json', { cache: 'no-cache' })
            .then((answer) => (answer.ok ? answer.json() : null))
            .catch(() => null);
        const named = Array.isArray(list?.origins) ? list.origins : [];
        const isOrigin = (text) => typeof text === 'string' && /^https?:\/\/[^\/*\s]+$/.test(text);
        const allowed = new Set([location.origin, ...named.filter(isOrigin)]);
        const known = location.ancestorOrigins?.[0];
        const origins = [...allowed].filter((origin) => known === undefined || origin === known);
        return origins.length === 0 ? null : { parent, allowed, origins };
    })()""",
)

private fun postTo(page: JsAny, message: String): Unit =
    js("page.origins.forEach((origin) => page.parent.postMessage(JSON.parse(message), origin))")

private fun hear(page: JsAny, take: (String) -> Unit): Unit = js(
    """addEventListener('message', ({ source, origin, data }) => {
        if (source === page.parent && page.allowed.has(origin) && data?.robotran === 1) take(JSON.stringify(data));
    })""",
)
