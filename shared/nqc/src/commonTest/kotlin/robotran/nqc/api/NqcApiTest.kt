package robotran.nqc.api

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.NqcOptions
import robotran.nqc.NqcResult
import robotran.nqc.compileNqc
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

class NqcApiTest {
    @Test
    fun `every name can be used`() {
        for (isOld in listOf(false, true)) {
            for (target in FirmwareTarget.entries) {
                NqcApi.of(target, isOld).values.forEach { check(it, NqcOptions(target, isOld)) }
            }
        }
    }

    private fun check(entry: NqcApiEntry, options: NqcOptions) {
        val definition = entry.definition as? ApiDefinition.Function
        val arguments = definition?.declaration.orEmpty().split(',').filter { it.isNotBlank() }.map { argumentFor(it) }
        val use = when {
            entry.name == "until" || entry.name == "wait" -> "${entry.name}(x == 1);"
            definition != null -> "${entry.name}(${arguments.joinToString()});"
            entry.parameters == null -> "x = ${entry.name};"
            else -> "x = ${entry.name}(${entry.parameters.joinToString { "1" }});"
        }
        val result = compileNqc("api.nqc", "int x; task main() { $use }", options)
        assertIs<NqcResult.Ready>(result, "$use ${(result as? NqcResult.HasErrors)?.diagnostics}")
    }

    private fun argumentFor(parameter: String): String = when {
        parameter.trim().startsWith("__sensor") -> "@0x90000"
        parameter.trim().endsWith("source") || parameter.trim().endsWith("target") -> "@0x10000"
        parameter.trim().endsWith("variable") -> "x"
        else -> "1"
    }

    @Test
    fun `every name has a sentence in every language`() {
        for (entry in NqcApi.of(FirmwareTarget.RCX2).values + NqcApi.of(FirmwareTarget.RCX).values) {
            val sentences = Language.entries.map { entry.help(it) }
            assertEquals(3, sentences.distinct().size, entry.name)
            assertTrue(sentences.all { it.endsWith('.') || it.endsWith(';') }, "${entry.name} $sentences")
        }
    }

    @Test
    fun `the second firmware has all names of the first`() {
        assertTrue(NqcApi.of(FirmwareTarget.RCX2).keys.containsAll(NqcApi.of(FirmwareTarget.RCX).keys))
    }
}
