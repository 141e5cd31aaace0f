plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant("commonMain", "robotran.robolang.template.templates", "shared/robolang/src/brick", "**/*")
    constant(
        "commonTest",
        "robotran.robolang.testPrograms",
        "shared/robolang/src/commonTest/resources/programs",
        "**/*.robo",
    )
    constant("commonTest", "robotran.robolang.examplePrograms", "examples", "*.robo")
    constant(
        "commonTest",
        "robotran.robolang.recordedTranslations",
        "shared/robolang/src/commonTest/resources/translations",
        "*.*",
    )
    constant("commonTest", "robotran.robolang.recordedPython", "shared/robolang/src/commonTest/resources/python", "*.*")
    constant("jvmTest", "robotran.robolang.lessonPrograms", "learning", "**/solution.robo")
    constant(
        "jvmTest",
        "robotran.robolang.oraclePrograms",
        "shared/robolang/src/jvmTest/resources/micropython/programs",
        "*.*",
    )
    blocks("commonTest", "robotran.robolang.documentedPrograms", "docs", "*.md", "robolang")
    blocks("commonTest", "robotran.robolang.documentedTranslations", "docs", "*.md", "java translation")
    blocks("commonTest", "robotran.robolang.documentedPython", "docs", "*.md", "python translation")
    blocks("commonTest", "robotran.robolang.documentedBoardPrograms", "docs", "*.md", "robolang microbit")
    blocks("commonTest", "robotran.robolang.documentedBoardPython", "docs", "*.md", "python microbit")
    blocks("commonTest", "robotran.robolang.documentedGrammar", "docs", "robolang.md", "ebnf")
    constant("commonTest", "robotran.robolang.documents", "docs", "robolang.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language-support"))
            api(project(":shared:rcx-rom"))
            api(project(":shared:nxt"))
            api(project(":shared:hub"))
            api(project(":shared:microbit"))
        }
        commonTest {
            kotlin.srcDir("../nxt/src/fakeNxtTest/kotlin")
        }
        commonTest.dependencies {
            implementation(project(":shared:nqc"))
        }
        jvmTest {
            resources.srcDir("../nxj-library/src/brick/java")
        }
        jvmTest.dependencies {
            implementation(libs.bcel)
        }
    }
}

// MicroPython for the tests of Python comes with the web tools, which a build for wasm installs, as in check. Without them, a
// test says so.
if (rootProject.tasks.names.contains("setUpWebTools") && System.getProperty("os.arch") == "amd64") {
    tasks.matching { it.name == "jvmTest" }.configureEach {
        dependsOn(":setUpWebTools")
        systemProperty(
            "robotran.webTools",
            rootProject.tasks.named("setUpWebTools").get().destination.get().asFile.path,
        )
    }
}
