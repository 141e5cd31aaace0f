plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant("commonTest", "robotran.rom.brickScripts", "shared/rcx-rom/src/commonTest/resources/scripts", "**/*.txt")
    constant("commonTest", "robotran.rom.formulaTables", "shared/rcx-rom/src/commonTest/resources/tables", "*.txt")
    constant("commonTest", "robotran.rom.documents", "docs", "rcx.md")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language"))
        }
    }
}
