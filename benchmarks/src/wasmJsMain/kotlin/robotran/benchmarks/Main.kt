@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.benchmarks

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.promise
import kotlin.js.Promise

/** Adds the object `benchmarks` to the page: `names`, separated by commas, and the async `measure(name)`. */
fun main() {
    val scope = CoroutineScope(SupervisorJob() + Dispatchers.Default)
    publish(
        names = BENCHMARKS.keys.joinToString(","),
        measure = { name -> scope.promise { measured(name).toJsString() } },
    )
}

private fun publish(names: String, measure: (String) -> Promise<JsString>): Unit =
    js("{ globalThis.benchmarks = { names, measure }; }")
