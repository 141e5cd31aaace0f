@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.benchmarks

import kotlinx.coroutines.DelicateCoroutinesApi
import kotlinx.coroutines.GlobalScope
import kotlinx.coroutines.promise
import kotlin.js.Promise

/** Gives the page the object `benchmarks`: `names` with commas between them, and `measure(name)`, which promises a line. */
@OptIn(DelicateCoroutinesApi::class)
fun main() =
    publish(
        names = BENCHMARKS.keys.joinToString(","),
        measure = { name -> GlobalScope.promise { measured(name).toJsString() } },
    )

private fun publish(
    names: String,
    measure: (String) -> Promise<JsString>,
): Unit = js("{ globalThis.benchmarks = { names, measure }; }")
