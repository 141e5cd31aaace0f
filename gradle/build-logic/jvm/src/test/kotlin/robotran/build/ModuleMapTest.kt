package robotran.build

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith

class ModuleMapTest {
    private val map =
        ModuleMap.parse(
            """
            # Architecture

            | module | package | holds | may use | kind |
            |---|---|---|---|---|
            | `shared/rom` | `robotran.rom` | the brick | - | core |
            | `shared/world` | `robotran.world` | the world | `shared/rom` | core |
            | `shared/ink` | `robotran.world.ink`, `robotran.pens` | ink | `shared/world` | core |
            | `app` | `robotran.app` | the app | `shared/rom`, `shared/world` | app |

            | room | packages |
            |---|---|
            | maze | `robotran.app.maze`, `robotran.app.walls` |
            | race | `robotran.app.race` |

            | constants of | only in |
            |---|---|
            | `Kind` | `shared/rom/src/commonMain/kotlin/rom`, `app/src/commonMain/kotlin/Kinds.kt` |

            More words.
            """.trimIndent(),
        )

    private fun violations(folder: String, path: String, text: String) =
        map.violations(map.modules.single { it.folder == folder }, SourceFile("$folder/$path", text))

    @Test
    fun `a module may import itself and what the map allows it`() {
        val text = "package robotran.world.walls\n\nimport robotran.rom.Rom\nimport robotran.world.Pose\n"
        assertEquals(emptyList(), violations("shared/world", "src/commonMain/kotlin/Walls.kt", text))
    }

    @Test
    fun `a module may not import what the map does not allow it`() {
        val text = "package robotran.rom\n\nimport robotran.world.Pose\n"
        assertEquals(
            listOf(
                "shared/rom/src/commonMain/kotlin/Brick.kt: imports robotran.world.Pose, but shared/rom may not use " +
                    "shared/world",
            ),
            violations("shared/rom", "src/commonMain/kotlin/Brick.kt", text),
        )
    }

    @Test
    fun `a test may import any module`() {
        val text = "package robotran.rom\n\nimport robotran.world.Pose\n"
        assertEquals(emptyList(), violations("shared/rom", "src/commonTest/kotlin/BrickTest.kt", text))
        assertEquals(
            emptyList(),
            violations("app", "src/test/kotlin/AppTest.kt", "package robotran.app\n\nimport robotran.rom.Rom\n"),
        )
    }

    @Test
    fun `a file must be in its module's package`() {
        assertEquals(1, violations("shared/rom", "src/commonMain/kotlin/Brick.kt", "package robotran.world\n").size)
    }

    @Test
    fun `a module may have several packages, some below that of another module`() {
        fun found(folder: String, name: String, import: String = "robotran.world.Pose") =
            violations(folder, "src/commonMain/kotlin/Ink.kt", "package $name\n\nimport $import\n").size
        assertEquals(0, found("shared/ink", "robotran.world.ink"))
        assertEquals(0, found("shared/ink", "robotran.pens.thin", "robotran.world.ink.Ink"))
        assertEquals(1, found("shared/ink", "robotran.world.walls"))
        assertEquals(1, found("shared/world", "robotran.world.ink"))
        assertEquals(1, found("shared/world", "robotran.world", "robotran.pens.Pen"))
    }

    @Test
    fun `a room imports no other room`() {
        fun found(name: String, import: String, path: String = "src/main/kotlin/Maze.kt") =
            violations("app", path, "package $name\n\nimport $import\n")
        assertEquals(
            listOf("app/src/main/kotlin/Maze.kt: imports robotran.app.race.Lap, which belongs to another room"),
            found("robotran.app.maze.hard", "robotran.app.race.Lap"),
        )
        assertEquals(emptyList(), found("robotran.app.maze", "robotran.app.walls.Wall"))
        assertEquals(emptyList(), found("robotran.app", "robotran.app.race.Lap"))
        assertEquals(emptyList(), found("robotran.app.maze", "robotran.app.shared.Clock"))
        assertEquals(emptyList(), found("robotran.app.maze", "robotran.app.race.Lap", "src/test/kotlin/MazeTest.kt"))
    }

    @Test
    fun `a core module knows no clock and no platform`() {
        val imports = listOf("java.io.File", "kotlin.time.TimeSource", "kotlin.math.sin", "kotlin.math.sqrt")
        val text = "package robotran.rom\n\n" + imports.joinToString("") { "import $it\n" }
        assertEquals(3, violations("shared/rom", "src/commonMain/kotlin/Brick.kt", text).size)
        assertEquals(0, violations("shared/rom", "src/jvmTest/kotlin/BrickTest.kt", text).size)
    }

    @Test
    fun `constants of a registered type stand in registries and tests alone`() {
        fun found(folder: String, path: String) =
            violations(folder, path, "package robotran.${folder.substringAfterLast('/')}\n\nval kind = Kind.RCX\n")
        assertEquals(
            listOf(
                "app/src/commonMain/kotlin/Menu.kt: names a constant of Kind, which is for the registries in the map " +
                    "alone",
            ),
            found("app", "src/commonMain/kotlin/Menu.kt"),
        )
        assertEquals(emptyList(), found("app", "src/commonMain/kotlin/Kinds.kt"))
        assertEquals(emptyList(), found("shared/rom", "src/commonMain/kotlin/rom/Rom.kt"))
        assertEquals(emptyList(), found("app", "src/commonTest/kotlin/MenuTest.kt"))
        val others = "package robotran.app\n\nval all = Kind.entries + OtherKind.RCX\n"
        assertEquals(emptyList(), violations("app", "src/commonMain/kotlin/Menu.kt", others))
    }

    @Test
    fun `a map that names an unknown module is refused`() {
        assertFailsWith<IllegalArgumentException> {
            ModuleMap.parse(
                "| module | package | holds | may use | kind |\n|---|---|---|---|---|\n| `a` | `a` | - | `b` | core " +
                    "|\n",
            )
        }
        assertFailsWith<IllegalArgumentException> { ModuleMap.parse("no table at all") }
    }
}
