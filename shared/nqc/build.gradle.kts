plugins {
    id("robotran.core")
    id("robotran.texts")
}

texts {
    packed("commonMain", "robotran.nqc.api.apiTexts", "shared/nqc/src/api", "**/*")
    constant("commonTest", "robotran.nqc.vectorFiles", "shared/nqc/src/commonTest/resources/vectors", "*")
    constant("commonTest", "robotran.nqc.documents", "docs", "nqc.md")
    blocks("commonTest", "robotran.nqc.documentedPrograms", "docs", "nqc.md", "nqc")
}

kotlin {
    sourceSets {
        commonMain.dependencies {
            api(project(":shared:language-support"))
            api(project(":shared:language"))
            api(project(":shared:lego-firmware"))
        }
    }
}
