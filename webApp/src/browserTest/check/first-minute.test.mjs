// The first minute of a pupil with a phone.
import { testFirstMinute } from '../first-minute.mjs';
import { PHONE } from '../set-up.mjs';

testFirstMinute('phone', PHONE);
