plugins {
    id("robotran.core")
    id("robotran.texts")
    id("robotran.lejos-library")
}

texts {
    constant("commonMain", "robotran.lejos.librarySources", "shared/lejos-library/src/brick/java", "**/*.java")
    constant("jvmTest", "robotran.lejos.documentedNatives", "shared/lejos-library/src/brick", "natives.md")
    constant("jvmTest", "robotran.lejos.testPrograms", "shared/lejos-library/src/commonTest/resources/programs", "**/*.java")
    constant("jvmTest", "robotran.lejos.examplePrograms", "examples/lejos", "*.java")
    constant("jvmTest", "robotran.lejos.lejosDocument", "docs", "lejos.md")
    blocks("jvmTest", "robotran.lejos.documentedPrograms", "docs", "lejos.md", "java")
}

kotlin {
    sourceSets {
        jvmTest.dependencies {
            implementation(libs.bcel)
            implementation(libs.ecj)
        }
    }
}
