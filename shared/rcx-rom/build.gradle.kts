plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant(
        "commonTest",
        "robotran.rcxrom.brickScripts",
        "shared/rcx-rom/src/commonTest/resources/scripts",
        "**/*.txt",
    )
    constant("commonTest", "robotran.rcxrom.formulaTables", "shared/rcx-rom/src/commonTest/resources/tables", "*.txt")
    constant("commonTest", "robotran.rcxrom.documents", "docs", "rcx.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:brick"))
        }
    }
}
