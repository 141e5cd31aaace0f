plugins {
    id("robotran.core")
    id("robotran.texts")
    id("robotran.brick-programs")
}

texts {
    constant(
        "commonTest",
        "robotran.tinyvm.testPrograms",
        "shared/lejos-library/src/commonTest/resources/programs",
        "**/*.java",
    )
    blocks("jvmTest", "robotran.tinyvm.documentedPrograms", "docs", "lejos.md", "java")
    constant("commonTest", "robotran.tinyvm.documentedNatives", "shared/lejos-library/src/brick", "natives.md")
}

brickPrograms {
    constant("commonTest", "robotran.tinyvm.compiledPrograms", "shared/lejos-library/src/commonTest/resources/programs")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
        }
        commonTest.dependencies {
            implementation(project(":shared:lejos-library"))
        }
    }
}
