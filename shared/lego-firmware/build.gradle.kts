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
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:rcx-rom"))
        }
    }
}
