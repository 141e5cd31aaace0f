plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.robolang.testPrograms", "shared/robolang/src/commonTest/resources/programs", "**/*.robo")
    constant("commonTest", "robotran.robolang.examplePrograms", "examples", "*.robo")
    blocks("commonTest", "robotran.robolang.documentedPrograms", "docs", "robolang.md", "robolang")
    blocks("commonTest", "robotran.robolang.documentedGrammar", "docs", "robolang.md", "ebnf")
    constant("commonTest", "robotran.robolang.documents", "docs", "robolang.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
        }
    }
}
