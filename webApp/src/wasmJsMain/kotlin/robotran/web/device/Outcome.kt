@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.device

import kotlinx.coroutines.await
import kotlin.js.Promise

/** What a promise of the browser has come to: [value], or the name of the error that it was rejected with. */
internal external interface Outcome<T : JsAny?> : JsAny {
    val value: T
    val error: String?
}

/** Waits for this promise. A rejection is no exception, since Kotlin's cannot tell the kind of error. */
internal suspend fun <T : JsAny?> Promise<T>.outcome(): Outcome<T> = outcomeOf(this).await()

private fun <T : JsAny?> outcomeOf(promise: Promise<T>): Promise<Outcome<T>> = js(
    """promise.then(
        (value) => ({ value, error: null }),
        (error) => ({ value: null, error: String(error && error.name || error) }),
    )""",
)
