plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    constant(
        "commonTest",
        "robotran.legofirmware.vectorFiles",
        "shared/lego-firmware/src/commonTest/resources/vectors",
        "*",
    )
    constant(
        "commonTest",
        "robotran.legofirmware.testPrograms",
        "shared/lego-firmware/src/commonTest/resources/programs",
        "**/*.lasm",
    )
    constant("commonTest", "robotran.legofirmware.documents", "docs", "lego-firmware.md")
    blocks("commonTest", "robotran.legofirmware.documentedPrograms", "docs", "lego-firmware.md", "lasm")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language-support"))
            api(project(":shared:rcx-rom"))
        }
    }
}
