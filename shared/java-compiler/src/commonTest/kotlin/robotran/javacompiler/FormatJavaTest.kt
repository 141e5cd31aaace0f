package robotran.javacompiler

import robotran.javacompiler.edit.JavaSyntax
import kotlin.test.Test
import kotlin.test.assertEquals

class FormatJavaTest {
    @Test
    fun `our examples are laid out already`() {
        for (examples in listOf(examplePrograms, nxjExamplePrograms)) {
            for ((name, source) in examples) assertEquals(source, JavaSyntax.format(source), name)
        }
    }

    @Test
    fun `blocks, branches without brackets and lines that go on find their places`() = assertEquals(
        """
        class A {
            /**
             * Goes.
             */
            void go() {
                if (x)
                    stop();
                else {
                    int sum = 1 +
                            2;
                    call(1,
                            2);
                }
            }

            int[] a = {
                1,
                2,
            };
        }

        """.trimIndent(),
        JavaSyntax.format(
            """


            class A {
            /**
            * Goes.
            */
              void go()   {
            if (x)
            stop();
            else {
            int sum = 1 +
            2;
            call(1,
            2);
            }
            }



            int[] a = {
            1,
            2,
            };
            }
            """.trimIndent().replace("go()   {", "go() {"),
        ),
    )

    @Test
    fun `brackets that do not match do no harm`() {
        assertEquals("}\n)\n", JavaSyntax.format("} \n  )"))
        assertEquals("", JavaSyntax.format(" \n\n"))
    }
}
