// Links to the page.
import { deflateRawSync } from 'node:zlib';

/** The fragment of a link to `content`, which is text or becomes JSON: of the kind `p`, a project, `w`, a world, or `c`, a course. */
export const linkTo = (kind, content) =>
  `#${kind}=a${deflateRawSync(typeof content === 'string' ? content : JSON.stringify(content)).toString('base64url')}`;
