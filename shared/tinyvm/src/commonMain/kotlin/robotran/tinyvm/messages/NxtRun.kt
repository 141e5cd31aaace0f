package robotran.tinyvm.messages

/** Those of an NXT. */
internal val TinyVmRunMessages.nxt: NxtRunMessages get() = NxtRunMessages.of(language)
