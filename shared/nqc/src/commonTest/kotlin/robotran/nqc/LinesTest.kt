package robotran.nqc

import robotran.legofirmware.image.ChunkId
import robotran.legofirmware.image.ChunkKind
import kotlin.test.Test
import kotlin.test.assertEquals

class LinesTest {
    private val source = """
        |int x;
        |void step(int n)
        |{
        |    x += n;
        |}
        |task main()
        |{
        |    OnFwd(OUT_A);
        |    while (x < 3)
        |    {
        |        step(1);
        |    }
        |    for (x = 0; x < 3; x++)
        |        Wait(10);
        |}
    """.trimMargin()

    @Test
    fun `every instruction comes from a statement`() {
        val program = programOf(source)
        val lines = program.lines.getValue(ChunkId.MAIN).map { it.address to it.range.line }
        val expected = listOf(
            0 to 6,
            6 to 8,
            10 to 9,
            12 to 11,
            17 to 4,
            22 to 9,
            30 to 13,
            35 to 13,
            42 to 14,
            46 to 13,
        )
        assertEquals(expected, lines)
    }

    @Test
    fun `every variable belongs to its task, its subroutine or all`() {
        val tasks = "task main() { start music; repeat (3) { s(); Wait(rounds); } } task music() { int tone = 450; }"
        val table = programOf("int rounds; sub s() { int here = 1; SetUserDisplay(here, 0); } $tasks").variables
        assertEquals(mapOf(0 to listOf("rounds")), table.shared)
        val own = mapOf(
            ChunkId(ChunkKind.SUB, 0) to listOf("here"),
            ChunkId(ChunkKind.TASK, 1) to listOf("tone"),
        )
        assertEquals(own, table.own.mapValues { it.value.values.flatten() })
    }

    @Test
    fun `an address belongs to the line before it`() {
        val program = programOf(source)
        assertEquals(8, program.lineAt(ChunkId.MAIN, 8)?.range?.line)
        assertEquals(9, program.lineAt(ChunkId.MAIN, 10)?.range?.line)
    }
}
