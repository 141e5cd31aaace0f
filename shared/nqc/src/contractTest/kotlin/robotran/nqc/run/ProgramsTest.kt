package robotran.nqc.run

import robotran.legofirmware.image.FirmwareTarget
import kotlin.test.Test
import kotlin.test.assertEquals

/** What programs do on a brick. */
class ProgramsTest {
    @Test
    fun `loops with break and continue`() = both(
        "sum" to 25,
        source = """
            int sum, i;
            task main()
            {
                for (i = 1; i < 100; i++)
                {
                    if (i % 2 == 0) continue;
                    if (i > 9) break;
                    sum += i;
                }
            }
        """,
    )

    @Test
    fun `loops inside of each other`() = both(
        "n" to 24,
        source = "int n; task main() { repeat (2) { repeat (3) { repeat (4) n++; } } }",
    )

    @Test
    fun `a count is computed once`() = both(
        "n" to 3,
        "k" to 6,
        source = "int n, k = 3; task main() { repeat (k) { n++; k++; } }",
    )

    @Test
    fun `a switch falls through`() = both(
        "a" to 111,
        "b" to 100,
        "c" to 1,
        source = """
            int a, b, c, i;
            void pick(int what, int &result)
            {
                switch (what)
                {
                    case 1: result += 1;
                    case 2: result += 10;
                    default: result += 100; break;
                    case 3: result += 1;
                }
            }
            task main() { pick(1, a); pick(7, b); pick(3, c); }
        """,
    )

    @Test
    fun `functions return early and have variables of their own`() = both(
        "x" to 5,
        "y" to 13,
        source = """
            int x, y;
            void atMost(int &value, const int limit) { if (value < limit) return; value = limit; }
            void twice(const int &e) { y = e; y += e; }
            task main() { x = 9; atMost(x, 5); atMost(x, 7); twice(x + 1); y++; }
        """,
    )

    @Test
    fun `goto leads anywhere in a task`() = both(
        "n" to 5,
        source = "int n; task main() { again: n++; if (n < 5) goto again; }",
    )

    @Test
    fun `tasks and subs work together`() = both(
        "n" to 3,
        "done" to 1,
        source = """
            int n, done;
            sub count() { n++; }
            task main() { start other; count(); until (done == 1); count(); }
            task other() { count(); Wait(5); done = 1; }
        """,
    )

    @Test
    fun `sorting an array`() = second(
        "first" to -3,
        "last" to 9,
        source = """
            int a[6], i, j, t, first, last;
            task main()
            {
                a[0] = 5; a[1] = 9; a[2] = -3; a[3] = 0; a[4] = 7; a[5] = 2;
                for (i = 0; i < 5; i++)
                    for (j = 0; j < 5 - i; j++)
                        if (a[j] > a[j + 1])
                        {
                            t = a[j];
                            a[j] = a[j + 1];
                            a[j + 1] = t;
                        }
                first = a[0];
                last = a[5];
            }
        """,
    )

    @Test
    fun `pointers and addresses`() = second(
        "x" to 8,
        "y" to 4,
        source = """
            int x, y, a[3];
            void add(int *p, int n) { *p = *p + n; }
            task main()
            {
                int *q;
                add(&x, 3);
                q = &y;
                add(q, 4);
                q = &x;
                *q += 5;
            }
        """,
    )

    @Test
    fun `an event interrupts`() = second(
        "caught" to 2,
        "reached" to 0,
        source = """
            int caught, reached;
            task main()
            {
                ClearTimer(0);
                SetEvent(1, Timer(0), EVENT_TYPE_HIGH);
                SetUpperLimit(1, 2);
                SetEvent(2, Message(), EVENT_TYPE_MESSAGE);
                monitor (EVENT_MASK(1) | EVENT_MASK(2)) { Wait(1000); reached = 1; }
                catch (EVENT_MASK(2)) { caught = 1; }
                catch (EVENT_MASK(1)) { caught = 2; }
            }
        """,
    )

    private fun both(vararg expected: Pair<String, Int>, source: String) =
        FirmwareTarget.entries.forEach { check(source, it, expected.toMap()) }

    private fun second(vararg expected: Pair<String, Int>, source: String) =
        check(source, FirmwareTarget.RCX2, expected.toMap())

    private fun check(source: String, target: FirmwareTarget, expected: Map<String, Int>) =
        assertEquals(expected, variablesAfter(source, target).filterKeys { it in expected }, "$target $source")
}
