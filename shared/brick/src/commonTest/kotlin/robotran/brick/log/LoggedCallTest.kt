package robotran.brick.log

import robotran.brick.kind.BrickKind
import kotlin.test.Test
import kotlin.test.assertEquals

class LoggedCallTest {
    @Test
    fun `a line of the log tells time, call, meaning and place`() {
        assertEquals("5 drawString hello 0 1 ; show \"hello\" ; 7", ShownCall(5, 7).text)
        assertEquals("5 drawString hello 0 1 ; show \"hello\" ; Robot.java:7", ShownCall(5, 7, "Robot.java").text)
        assertEquals("5 clear ; clear ; firmware", ShownCall(5, 0, callText = "clear", meaning = "clear").text)
        assertEquals("5 clear ; clear ; firmware", ShownCall(5, 0, "Robot.java", "clear", "clear").text)
    }

    @Test
    fun `in a table the name of a call stands before its arguments`() {
        val calls = listOf(ShownCall(5, 7), ShownCall(6, 0, callText = "clear", meaning = "clear"))
        assertEquals(
            listOf(
                "milliseconds,group,address,arguments,meaning,line,outcome",
                "5,display,drawString,hello 0 1,\"show \"\"hello\"\"\",7,done",
                "6,display,clear,,clear,,done",
                "",
            ),
            calls.toCsv().split("\r\n"),
        )
    }

    @Test
    fun `each brick has its groups, and all of them belong to a brick`() {
        assertEquals(CallGroup.entries.toSet(), BrickKind.entries.flatMap { it.callGroups }.toSet())
        assertEquals(
            listOf("SENSORS", "MOTORS", "BUTTONS", "DISPLAY", "SOUND", "POWER", "INFRARED", "TIMER", "UNKNOWN"),
            BrickKind.RCX.callGroups.map { it.name },
        )
    }
}
