// The parts of the app that come after the first picture, on larger screens than in check.
import { choicesOn, firstPictureOn } from '../parts.mjs';

firstPictureOn('tablet');
firstPictureOn('laptop');
choicesOn('laptop');
