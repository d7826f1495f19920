/* To be made by a full run. */
{ "fx_sqrt", 1, 0 },
