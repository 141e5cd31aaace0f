package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.nqc.NqcResult
import robotran.nqc.compileNqc
import robotran.nqc.messages.NqcMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class WordHelpTest {
    private fun english(programLanguage: ProgramLanguage, text: String): WordHelp? =
        helpOn(Language.ENGLISH, programLanguage, text.replace("|", ""), text.indexOf('|'), brick = BrickKind.RCX)

    private fun wordIn(programLanguage: ProgramLanguage, text: String): String? = english(programLanguage, text)?.word

    @Test
    fun `every word of the grammar and every function has help in every language`() {
        val page = robolangPages.getValue("robolang.md")
        val grammar = page.substringAfter("```ebnf").substringBefore("```")
        val words = Regex("\"([a-z]+)\"").findAll(grammar).map { it.groupValues[1] }.toSet()
        val table = page.substringAfter("| `random(a, b)` |").substringBefore("These functions")
        val functions = Regex("\\b([a-z]+2?)\\([a-z]").findAll("random(a$table").map { it.groupValues[1] }.toSet()
        assertTrue(words.size > 60 && functions.size > 12, "found $words and $functions")
        for (word in words + functions) {
            for (language in Language.entries) {
                val help =
                    assertNotNull(WordHelp.of(language, ProgramLanguage.ROBOLANG, word, brick = BrickKind.RCX), word)
                assertEquals(language, help.sentenceLanguage, word)
                assertTrue(
                    help.forms.all {
                        it.isNotBlank()
                    } && help.forms.any { word in it },
                    "$word has the forms ${help.forms}",
                )
                assertTrue(word in assertNotNull(help.example), "the example of $word does not use it")
            }
        }
    }

    @Test
    fun `every sentence is one line that ends in a full stop, and each language has its own`() {
        for (code in ProgramLanguage.entries) {
            for (brick in BrickKind.entries) {
                for (word in WordHelp.words(code, brick)) {
                    val said = Language.entries.map { assertNotNull(WordHelp.of(it, code, word, brick)).sentence }
                    assertTrue(said.all { it.endsWith(".") && it.length <= 130 && '!' !in it }, "$word: $said")
                    assertEquals(Language.entries.size, said.toSet().size, "$word: $said")
                }
            }
        }
    }

    @Test
    fun `usual functions of NQC have an example, which has no mistakes`() {
        val examples = WordHelp.words(ProgramLanguage.NQC, brick = BrickKind.RCX)
            .associateWith { WordHelp.of(Language.ENGLISH, ProgramLanguage.NQC, it, brick = BrickKind.RCX)?.example }
        assertTrue("    SetSensor(SENSOR_1, SENSOR_TOUCH);\n" in assertNotNull(examples["SetSensor"]))
        for (word in listOf("OnFwd", "Off", "Wait", "SetPower", "PlaySound", "PlayTone", "OnFor", "SendMessage")) {
            assertNotNull(examples[word], word)
        }
        for ((word, example) in examples) {
            val result = compileNqc("try.nqc", example ?: continue, messages = NqcMessages.of(Language.ENGLISH))
            assertEquals(emptyList(), assertIs<NqcResult.Success>(result, word).warnings, word)
        }
    }

    @Test
    fun `the word is found wherever the cursor stands in it or right behind it`() {
        for (text in listOf("|forward 20", "for|ward 20", "forward| 20", "beep\n  FORWARD| 20")) {
            assertEquals("forward", wordIn(ProgramLanguage.ROBOLANG, text))
        }
    }

    @Test
    fun `there is no help on numbers, names, comments and emptiness`() {
        for (text in listOf("|", "forward 2|0", "var side| = 3", "beep // for|ward", "beep  |  ")) {
            assertNull(english(ProgramLanguage.ROBOLANG, text), text)
        }
        assertEquals("side", wordAt("var side = 3", 6))
        assertNull(wordAt("// side", 5))
        assertNull(wordAt("beep", 99))
    }

    @Test
    fun `two slashes in a text are no comment`() {
        assertEquals("Motor", wordIn(ProgramLanguage.JAVA, "x = \"a//b\"; Motor|.A"))
    }

    @Test
    fun `a method is known by the class of what stands before it`() {
        assertEquals("Motor.forward", wordIn(ProgramLanguage.JAVA, "Motor.A.for|ward();"))
        assertEquals("Motor.A", wordIn(ProgramLanguage.JAVA, "Motor.A|.forward();"))
        assertEquals("Motor", wordIn(ProgramLanguage.JAVA, "Mot|or.A.forward();"))
        assertEquals("Sensor.readValue", wordIn(ProgramLanguage.JAVA, "int x = Sensor.S2.read|Value();"))
        assertEquals("Thread.sleep", wordIn(ProgramLanguage.JAVA, "Thread.sleep|(1000);"))
    }

    @Test
    fun `a variable's class is looked up where it is declared, and a member in the classes above it`() {
        val program = "TimingNavigator robot = new TimingNavigator(Motor.C, Motor.A, 5f, 1.8f);\nrobot.trav|el(20);"
        assertEquals("TimingNavigator.travel", wordIn(ProgramLanguage.JAVA, program))
        assertEquals(
            "Thread.sleep",
            wordIn(ProgramLanguage.JAVA, "class Walk extends Thread {\n void go() { sle|ep(10); }\n}"),
        )
        assertEquals("Thread.start", wordIn(ProgramLanguage.JAVA, "Thread walk = null; walk.sta|rt();"))
    }

    @Test
    fun `what nobody has translated is in English and says so`() {
        val help = assertNotNull(helpOn(Language.GERMAN, ProgramLanguage.JAVA, "Servo", 2, brick = BrickKind.RCX))
        assertEquals(Language.ENGLISH, help.sentenceLanguage)
        assertTrue(help.sentence.endsWith("."), help.sentence)
        val motor =
            assertNotNull(helpOn(Language.GERMAN, ProgramLanguage.JAVA, "Motor.A.stop()", 9, brick = BrickKind.RCX))
        assertEquals("Bremst den Motor.", motor.sentence)
        assertEquals(Language.GERMAN, motor.sentenceLanguage)
    }

    @Test
    fun `what the library's comments say is not another thing than our English`() {
        for (word in listOf(
            "Motor.forward",
            "Sensor.readValue",
            "LCD.showNumber",
            "Sound.playTone",
            "Button.isPressed",
            "TextLCD.print",
        )) {
            val (owner, member) = word.split('.')
            assertEquals(
                WordHelp.of(Language.ENGLISH, ProgramLanguage.JAVA, word, brick = BrickKind.RCX)?.sentence,
                lejosMember(owner, member, BrickKind.RCX)?.second?.sentence,
            )
        }
    }

    @Test
    fun `the members of the library are written as they are declared`() {
        assertEquals("setPower(int power)", lejosMember("Motor", "setPower", BrickKind.RCX)?.second?.form)
        assertEquals("Motor", lejosMember("Motor", "A", BrickKind.RCX)?.second?.type)
        assertNull(lejosMember("Motor", "run", BrickKind.RCX))
        assertNull(lejosMember("Nothing", "run", BrickKind.RCX))
    }
}
