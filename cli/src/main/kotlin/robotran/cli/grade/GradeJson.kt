package robotran.cli.grade

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import robotran.cli.console.jsonOutput
import robotran.simulation.RunReport
import robotran.simulation.grade.Grade

/**
 * All grades as JSON: the file and title of the `world`, and `programs`. Each program has its file and either
 * `errors`, or the number of seeds it `passed` and its `runs`: `world` for a variation of the assignment's world,
 * `seed`, `passed` and the `report` of `robotran run`.
 */
internal fun gradeJson(worldFile: String, worldTitle: String, programs: List<ProgramGrades>): String {
    val report = buildJsonObject {
        put("world", worldFile)
        put("title", worldTitle)
        put("programs", JsonArray(programs.map(::json)))
    }
    return jsonOutput.encodeToString(JsonObject.serializer(), report)
}

private fun json(program: ProgramGrades): JsonObject = buildJsonObject {
    put("program", program.name)
    when (program) {
        is ProgramGrades.Failure -> put("mistakes", JsonArray(program.reasons.map(::JsonPrimitive)))

        is ProgramGrades.Success -> {
            put("passed", program.passed)
            put("runs", JsonArray(program.grades.zip(program.worlds, ::json)))
        }
    }
}

private fun json(grade: Grade, world: String): JsonObject = buildJsonObject {
    if (world.isNotEmpty()) put("world", world)
    put("seed", grade.seed)
    put("passed", grade.passed)
    put("report", jsonOutput.encodeToJsonElement(RunReport.serializer(), grade.report))
}
