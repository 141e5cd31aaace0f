// The first minute of a pupil with a phone held across, and with a tablet.
import { testFirstMinute } from '../first-minute.mjs';
import { PHONE, TABLET } from '../set-up.mjs';

testFirstMinute('phone-across', { width: PHONE.height, height: PHONE.width });
testFirstMinute('tablet', TABLET);
