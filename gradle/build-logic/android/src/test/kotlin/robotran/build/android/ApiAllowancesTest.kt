package robotran.build.android

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class ApiAllowancesTest {
    private val allowances = ApiAllowances(
        """
        # a remark
        androidx/*Api28Impl* -> android/view/* # asks for 28

        nobody -> nothing # never
        """,
    )

    @Test
    fun `a use is allowed where both patterns fit`() {
        assertTrue(allowances.allows(UsedApi.Use("android/view/View", "newer()V", "androidx/core/View\$Api28Impl.go")))
        assertFalse(allowances.allows(UsedApi.Use("android/view/View", "newer()V", "robotran/ui/Own.go")))
        assertFalse(allowances.allows(UsedApi.Use("android/text/Layout", null, "androidx/core/View\$Api28Impl.go")))
    }

    @Test
    fun `lines that allow nothing are told`() {
        allowances.allows(UsedApi.Use("android/view/View", null, "androidx/core/View\$Api28Impl.go"))
        assertEquals(listOf("nobody -> nothing # never"), allowances.needless)
    }

    @Test
    fun `a line without a reason is refused`() {
        assertFailsWith<IllegalArgumentException> { ApiAllowances("androidx/* -> *") }
        assertFailsWith<IllegalArgumentException> { ApiAllowances("androidx/* # because") }
    }
}
