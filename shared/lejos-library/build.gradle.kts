plugins {
    id("robotran.core")
    id("robotran.texts")
    id("robotran.lejos-library")
}

texts {
    constant("commonMain", "robotran.lejoslibrary.librarySources", "shared/lejos-library/src/brick/java", "**/*.java")
    constant("jvmTest", "robotran.lejoslibrary.documentedNatives", "shared/lejos-library/src/brick", "natives.md")
    constant(
        "jvmTest",
        "robotran.lejoslibrary.testPrograms",
        "shared/lejos-library/src/commonTest/resources/programs",
        "**/*.java",
    )
    constant("jvmTest", "robotran.lejoslibrary.examplePrograms", "examples/lejos", "*.java")
    constant("jvmTest", "robotran.lejoslibrary.lejosDocument", "docs", "lejos.md")
    blocks("jvmTest", "robotran.lejoslibrary.documentedPrograms", "docs", "lejos.md", "java")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:tinyvm"))
        }
        jvmTest.dependencies {
            implementation(libs.bcel)
            implementation(libs.ecj)
        }
    }
}
