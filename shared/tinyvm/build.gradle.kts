plugins {
    id("robotran.core")
    id("robotran.texts")
    id("robotran.brick-programs")
    id("robotran.nxj-web")
}

texts {
    constant(
        "commonTest",
        "robotran.tinyvm.testPrograms",
        "shared/lejos-library/src/commonTest/resources/programs",
        "**/*.java",
    )
    constant(
        "commonTest",
        "robotran.tinyvm.nxjPrograms",
        "shared/nxj-library/src/commonTest/resources/programs",
        "**/*.java",
    )
    constant("commonTest", "robotran.tinyvm.documentedNxjNatives", "shared/nxj-library/src/brick", "natives.md")
    blocks("jvmTest", "robotran.tinyvm.documentedPrograms", "docs", "lejos.md", "java")
    constant("commonTest", "robotran.tinyvm.documentedNatives", "shared/lejos-library/src/brick", "natives.md")
}

brickPrograms {
    constant("commonTest", "robotran.tinyvm.compiledPrograms", "shared/lejos-library/src/commonTest/resources/programs")
    nxjConstant(
        "commonTest",
        "robotran.tinyvm.compiledNxjPrograms",
        "shared/nxj-library/src/commonTest/resources/programs",
    )
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
            api(project(":shared:nxt"))
        }
        commonTest {
            kotlin.srcDir("src/nxjExpectations/kotlin")
        }
        commonTest.dependencies {
            implementation(project(":shared:lejos-library"))
            implementation(project(":shared:nxj-library"))
            implementation(libs.coroutines.test)
        }
    }
}
