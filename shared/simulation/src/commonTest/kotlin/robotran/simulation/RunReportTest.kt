package robotran.simulation

import kotlinx.coroutines.test.runTest
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import robotran.brick.program.ProgramFailure
import robotran.brick.program.ProgramRun
import robotran.brick.program.ProgramStatus
import robotran.rcxrom.program.RcxProgram
import robotran.rcxrom.program.Rom
import robotran.world.Goal
import robotran.world.GoalCondition.All
import robotran.world.GoalCondition.InkLength
import robotran.world.GoalCondition.NeverTouch
import robotran.world.file.BuiltInWorlds
import robotran.world.writeThousandths
import kotlin.test.Test
import kotlin.test.assertEquals

class RunReportTest {
    private object FailingProgram : RcxProgram {
        override val name = "failing"

        override fun start(rom: Rom) = object : ProgramRun {
            override val sourceLine = 3

            override fun resume(steps: Int) = ProgramStatus.Failed(ProgramFailure("There is nothing to divide by.", 3))
        }
    }

    @Test
    fun `a report has the promised fields in their order`() = runTest {
        val report = runToEnd(ScriptedProgram.square).report()
        val fields = Json.parseToJsonElement(report.toJson()).jsonObject
        assertEquals(
            listOf(
                "status",
                "seconds",
                "pose",
                "inkCentimetres",
                "bumps",
                "lcd",
                "romCalls",
                "traceHash",
                "error",
                "goals",
            ),
            fields.keys.toList(),
        )
        assertEquals(listOf("x", "y", "heading"), fields.getValue("pose").jsonObject.keys.toList())
        assertEquals("\"ended\"", fields["status"].toString())
        assertEquals("null", fields["error"].toString())
        assertEquals("[]", fields["goals"].toString())
    }

    @Test
    fun `a report can be read back`() = runTest {
        val report = runToEnd(ScriptedProgram { forward(1.0) }).report()
        assertEquals(report, Json.decodeFromString(RunReport.serializer(), report.toJson()))
    }

    @Test
    fun `a program under way is running`() = runTest {
        assertEquals(RunStatus.RUNNING, startRun(ScriptedProgram.square).report().status)
    }

    @Test
    fun `a failed program is told with its line`() = runTest {
        val report = runToEnd(FailingProgram).report()
        assertEquals(RunStatus.FAILED, report.status)
        assertEquals("Line 3: There is nothing to divide by.", report.error)
    }

    @Test
    fun `goals are told with their parts`() = runTest {
        val goals =
            listOf(
                Goal(
                    All(
                        listOf(Goal(InkLength(2.0, null), says = "Draw."), Goal(NeverTouch(), says = "Touch nothing.")),
                    ),
                ),
            )
        val session = runToEnd(
            ScriptedProgram {
                penDown()
                forward(3.0)
            },
            BuiltInWorlds.plain.copy(goals = goals),
        )
        val expected = listOf("met" to "pending", "met" to "met")
        for ((draws, touches) in expected) {
            val all = Json.parseToJsonElement(
                session.report().toJson(),
            ).jsonObject.getValue("goals").jsonArray.single().jsonObject
            assertEquals(listOf("goal", "met", "status", "progress", "parts"), all.keys.toList())
            assertEquals("\"$touches\"", all["status"].toString())
            val parts = all.getValue("parts").jsonArray.map { it.jsonObject }
            assertEquals(listOf("\"Draw.\"", "\"Touch nothing.\""), parts.map { it["goal"].toString() })
            assertEquals(listOf("\"$draws\"", "\"$touches\""), parts.map { it["status"].toString() })
            session.finish()
        }
        assertEquals(session.report(), Json.decodeFromString(RunReport.serializer(), session.report().toJson()))
    }

    @Test
    fun `numbers are written with up to three decimals`() {
        assertEquals("20.0", writeThousandths(20.0))
        assertEquals("79.96", writeThousandths(79.9604))
        assertEquals("-0.125", writeThousandths(-0.1253))
        assertEquals("0.0", writeThousandths(-0.0004))
        assertEquals("1234567.001", writeThousandths(1234567.001))
    }
}
