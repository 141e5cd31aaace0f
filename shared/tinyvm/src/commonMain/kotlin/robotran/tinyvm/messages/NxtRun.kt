package robotran.tinyvm.messages

/** Those of an NXT. */
internal val RunMessages.nxt: NxtRunMessages get() = NxtRunMessages.of(language)
