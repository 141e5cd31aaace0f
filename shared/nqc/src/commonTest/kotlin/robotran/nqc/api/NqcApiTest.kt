package robotran.nqc.api

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.NqcOptions
import robotran.nqc.NqcResult
import robotran.nqc.compileNqc
import robotran.nqc.messages.NqcMessages
import robotran.nqc.tree.ParameterKind
import robotran.nqc.tree.Variable
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
        val function = entry.function
        val arguments = function?.parameters.orEmpty().map { argumentFor(it) }
        val use = when {
            entry.name == "until" || entry.name == "wait" -> "${entry.name}(x == 1);"
            function != null -> "${entry.name}(${arguments.joinToString()});"
            entry.parameters == null -> "x = ${entry.name};"
            else -> "x = ${entry.name}(${entry.parameters.joinToString { "1" }});"
        }
        val result =
            compileNqc("api.nqc", "int x; task main() { $use }", options, messages = NqcMessages.of(Language.ENGLISH))
        assertIs<NqcResult.Success>(result, "$use ${(result as? NqcResult.Failure)?.diagnostics}")
    }

    private fun argumentFor(parameter: Variable): String = when {
        parameter.parameter == ParameterKind.SENSOR -> "@0x90000"
        parameter.name == "source" || parameter.name == "target" -> "@0x10000"
        parameter.name == "variable" -> "x"
        else -> "1"
    }

    @Test
    fun `every name has a sentence in every language`() {
        for (entry in NqcApi.of(FirmwareTarget.RCX2).values + NqcApi.of(FirmwareTarget.RCX).values) {
            val sentences = Language.entries.map { entry.help(it) }
            assertEquals(Language.entries.size, sentences.distinct().size, entry.name)
            assertTrue(sentences.all { it.endsWith('.') || it.endsWith(';') }, "${entry.name} $sentences")
        }
    }

    @Test
    fun `the second firmware has all names of the first`() {
        assertTrue(NqcApi.of(FirmwareTarget.RCX2).keys.containsAll(NqcApi.of(FirmwareTarget.RCX).keys))
    }

    @Test
    fun `every tag of a doc comment is about a parameter, and every name in it exists`() {
        for (isOld in listOf(false, true)) {
            val api = NqcApi.of(FirmwareTarget.RCX2, isOld)
            for ((doc, entries) in api.values.groupBy { it.doc }) {
                val parameters = entries.flatMap { it.function?.parameters.orEmpty() }.map { it.name }.toSet()
                assertTrue(parameters.containsAll(doc.taggedParameters), "${entries.first().name} $parameters")
                assertTrue(api.keys.containsAll(parameters.flatMap { doc.namesFor(it) }), entries.first().name)
            }
        }
    }
}
