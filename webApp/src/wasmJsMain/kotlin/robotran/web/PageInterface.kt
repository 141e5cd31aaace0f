@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web

import kotlinx.coroutines.DelicateCoroutinesApi
import kotlinx.coroutines.GlobalScope
import kotlinx.coroutines.promise
import robotran.robolang.RobolangResult
import robotran.robolang.readRobolang
import robotran.ui.workshop.PENBOT_CALIBRATION
import robotran.ui.workshop.Workshop
import robotran.world.BuiltInWorlds
import robotran.world.Session
import robotran.world.physics.loadPhysicsEngine
import robotran.world.report
import robotran.world.runUnattended
import kotlin.js.Promise

/**
 * Gives the page that holds the workshop the object `robotran`:
 * - `report()` is the report of the workshop's run up to now, as JSON;
 * - `run(program, milliseconds)` promises `{ report, romLog }` of an unattended run of a Robolang text on the plain sheet, as
 *   `robotran run` makes it; it is refused with the first mistake of the text.
 */
internal fun openPageInterface(workshop: Workshop) =
    publish(report = { workshop.report().toJson() }, run = ::promiseRun)

@OptIn(DelicateCoroutinesApi::class)
private fun promiseRun(
    program: String,
    milliseconds: Int,
): Promise<JsAny?> =
    GlobalScope.promise {
        when (val result = readRobolang("program", program, PENBOT_CALIBRATION)) {
            is RobolangResult.Mistaken -> {
                error(result.diagnostics.first().let { "Line ${it.range.line}: ${it.message}" })
            }

            is RobolangResult.Ready -> {
                val session = Session(BuiltInWorlds.plain, listOf(result.program), loadPhysicsEngine())
                session.runUnattended(milliseconds)
                session.close()
                runResult(session.report().toJson(), session.romLog.entries.joinToString("") { it.text + "\n" })
            }
        }
    }

private fun runResult(
    report: String,
    romLog: String,
): JsAny = js("({ report, romLog })")

private fun publish(
    report: () -> String,
    run: (String, Int) -> Promise<JsAny?>,
): Unit = js("{ globalThis.robotran = { report, run }; }")
